"""Documents: the TMM-2 report, task sheets and their keys, as PDF, DOCX, Typst and Markdown."""
