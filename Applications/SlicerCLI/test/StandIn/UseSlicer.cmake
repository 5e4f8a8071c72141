set(stand_in_used TRUE)
