"""Courses: members, groups, rosters, and the time zone in which moments are told."""
