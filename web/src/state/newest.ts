// Work that is asked for faster than it is done.

/** One at a time, and after it only what is asked for then: what is asked for meanwhile is one call more, not as many. */
export function newestOnly(work: () => Promise<void>): () => void {
  let isBusy = false;
  let isStale = false;
  const run = async () => {
    isBusy = true;
    do {
      isStale = false;
      await work();
    } while (isStale);
    isBusy = false;
  };
  return () => {
    if (isBusy) {
      isStale = true;
    } else {
      void run();
    }
  };
}
