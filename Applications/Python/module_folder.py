# Usage: python3 module_folder.py PREFIX: prints the folder of modules below that installation prefix.
import sys
import sysconfig

schemes = sysconfig.get_scheme_names()
if sys.argv[1] == "/usr" and "deb_system" in schemes:
    scheme = "deb_system"
else:
    scheme = "posix_local" if "posix_local" in schemes else "posix_prefix"
path = sysconfig.get_path("platlib", scheme, vars={"base": "", "platbase": ""})
print(path.removeprefix("/local").lstrip("/"))
