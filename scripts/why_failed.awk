# SPDX-License-Identifier: Apache-2.0
# Reads a ctest log. Prints what each failed test said of its failures, or its last lines where it ended without a word.
/^[0-9]+\/[0-9]+ Testing: / { name = $3; said = ""; last = ""; take = 0; next }
/: Failure$|ERROR: .*Sanitizer|runtime error:|^SUMMARY: / { take = 12 }
/^\[ RUN |^\[       OK/ { take = 0 }
/^\[  FAILED  \]/ { take = 1 }
take > 0 { said = said "  " $0 "\n"; --take }
/^<end of output>/ { ended = 1 }
!ended { last = substr(last "  " $0 "\n", length(last) > 2000 ? index(substr(last, 400), "\n") + 400 : 1) }
/^Test Failed\.|^Test timed out|^\*\*\*/ { print "failed: " name "\n" (said != "" ? said : last); }
/^Test (Passed|Failed)\./ { ended = 0 }
