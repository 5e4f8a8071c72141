# cmake -DNPM=npm [-DONLY_RUN=ON] -P MoserHexNpmInstall.cmake     in a folder with package.json and package-lock.json
#
# Installs what package-lock.json names, with its checksums; from npm's own cache where it holds them. The packages' install
# scripts are not run. ONLY_RUN leaves out what only tests need.
set(only_run "")
if(ONLY_RUN)
  set(only_run --omit=dev)
endif()
execute_process(
  COMMAND ${NPM} ci ${only_run} --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error --fetch-retries=1
    --fetch-retry-mintimeout=2000 --fetch-timeout=120000
  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(NOTICE "${said}")
  message(FATAL_ERROR
    "npm could not install the packages of the HTML reports (three.js and esbuild among them), as said above. "
    "Without a network: build once where there is one, npm keeps the packages (npm config get cache); or name a registry that "
    "can be reached (npm config set registry URL). Or build without pages: -DMoserHex_BUILD_REPORTS=OFF.")
endif()
