X1000
WAITX   ; and then
;# for pmx-4ex-sa dmx-k-sa
;# error 2:6 END is missing below
