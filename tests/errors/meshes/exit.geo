// Exit in a comment is no command.
Point(1) = {0, 0, 0};
Exit;
