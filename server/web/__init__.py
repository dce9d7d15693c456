"""What is alike in every request: envelope, errors, language, limits, logs, templates, static files."""
