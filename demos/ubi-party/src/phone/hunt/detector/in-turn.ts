/** Calls a function for one value after the other: a result is that of its own value. */
export function inTurn<T, R>(act: (value: T) => Promise<R>): (value: T) => Promise<R> {
  let last: Promise<unknown> = Promise.resolve();
  return (value) => {
    const done = last.then(() => act(value));
    last = done.catch(() => undefined);
    return done;
  };
}
