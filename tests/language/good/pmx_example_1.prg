HSPD=20000      ;* Set the high speed to 20000 pulses/sec
LSPD=1000       ;* Set the low speed to 1000 pulses/sec
ACC=300         ;* Set the acceleration to 300 msec
EO=1            ;* Enable the motor power
X1000           ;* Move to 1000
WAITX           ;* Wait for X-axis move to complete
X0              ;* Move to zero
WAITX           ;* Wait for X-axis move to complete
END             ;* End of the program

; PMX manual, ch. 11, example 1, as printed.
;# for pmx-4ex-sa
;# lines 9
;# after 40 PX=0..999 did:move_X1000 state0=1
;# after 200 PX=0 did:move_X0 count:move_X0=1 state0=0 HSPD=20000 LSPD=1000 ACC=300 EO=1
