; No WAIT: the second move waits for the axis, the line behind a move does not.
X100
V1=1
X0
V2=1
END
;# for pmx-4ex-sa dmx-k-sa
;# after 20 V1=1 V2=0 line0=4
;# after 120 V2=1 count:move_X0=1 PX=0..99
;# after 300 PX=0 state0=0
