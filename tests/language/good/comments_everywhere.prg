; Comments where people write them.
	; behind a tab
***
* a star alone
V1=1;no blank
V2=2 ; one blank ; and another
V3=3 ** stars
   ;
;;;
END;
;# for pmx-4ex-sa dmx-k-sa
;# lines 4
;# warning 3:1 Begin a comment with ;
;# warning 4:1 Begin a comment with ;
;# warning 7:6 Begin a comment with ;
;# after 20 V1=1 V2=2 V3=3 state0=0
