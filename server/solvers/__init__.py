"""The reference solvers and the comparison of answers, for lecturers who write keys of their own."""
