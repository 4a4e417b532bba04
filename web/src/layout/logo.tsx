// A polished ball with its highlight.
export function Logo() {
  return <img class="logo" src="./icon.svg" width="26" height="26" alt="" />;
}
