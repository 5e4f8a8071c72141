# Doxygen's filter of the headers: words that stand in every ITK class, once; no line is added or removed before the last.
s|^  using Self = |  /** This class. */ using Self = |
s|^  using Superclass = |  /** The class it derives from. */ using Superclass = |
s|^  using Pointer = |  /** Counts its references. */ using Pointer = |
s|^  using ConstPointer = |  /** Counts its references. */ using ConstPointer = |
# Constructors of the base: Doxygen lists them anyhow, and overloads twice.
s|^  using \([A-Za-z]*\)::\1;.*||
/^  const char \*$/{
N
s|^  \(const char \*\n  GetNameOfClass() \)|  /** Its name without namespace. */ \1|
}
/^  void$/{
N
s|^  void\(\n  GenerateData() \)|  /** Makes the output; Update() calls it. */ void\1|
s|^  void\(\n  PrintSelf(\)|  /** Prints the options and the numbers of the last run. */ void\1|
}
# A getter right behind its setter has the setter's words.
/^  itkSet[A-Za-z]*Macro(/{
N
s|\n  itkGet\([A-Za-z]*\)Macro(\([A-Za-z]*\),|\n  /** \\copydoc Set\2 */ itkGet\1Macro(\2,|
}
# A page for each file, although it has no words of its own.
$a/** \\file */
