HSPD=20000      ;* Set the high speed to 20000 pulses/sec
LSPD=1000       ;* Set the low speed to 1000 pulses/sec
ACC=300         ;* Set the acceleration to 300 msec
EO=1            ;* Enable the motor power
V1=0            ;* Set variable 1 to value 0
WHILE V1<10     ;* Loop while variable 1 is less than 10
    X1000        ;* Move to zero
    WAITX        ;* Wait for X-axis move to complete
    X0           ;* Move to 1000
    V1=V1+1      ;* Increment variable 1
ENDWHILE        ;* Go back to WHILE statement
END

; DMX manual, ch. 11, example 3, as printed.
;# for dmx-k-sa
;# after 3000 count:move_X1000=10 count:move_X0=10 V1=10 PX=0 state0=0
