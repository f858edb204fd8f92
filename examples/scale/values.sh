#!/usr/bin/env bash
# Prints the table of the study: ten numbers of waves, ten depths and ten twists.
echo waves,depth,twist
for waves in 3 4 5 6 7 8 9 10 11 12; do
  for depth in 0 0.5 1 1.5 2 2.5 3 3.5 4 4.5; do
    for twist in 0 1 2 3 4 5 6 7 8 9; do
      echo "$waves,$depth,$twist"
    done
  done
done
