V1=1
PRG 0
V1=2
SUB 1
V1=3
END
SUB 1
ENDSUB
V1=4
V1=5
PRG 1
END
PRG 1
ENDSUB
END
ENDSUB
PRG 9
END
;# for pmx-4ex-sa dmx-k-sa
;# error 2:1 END is missing above
;# error 2:1 appears twice
;# error 4:1 END is missing above
;# error 6:1 ENDSUB
;# error 7:1 appears twice
;# error 9:1 outside any program
;# error 13:1 appears twice
;# error 14:1 A program ends with END
;# error 15:1 no program above this END
;# error 16:1 no SUB above
;# error 17:5 PRG 0 to PRG
