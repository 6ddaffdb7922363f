;# for pmx-4ex-sa dmx-k-sa
;# lines 0
;# after 20 state0=0
