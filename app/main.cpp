// The command `lustro`.
int main() { return 0; }
