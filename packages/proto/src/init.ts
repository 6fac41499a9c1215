/**
 * Argument of `encode` for a message: every member may be left out, at every depth. A member that
 * is given is written, also when it is 0, false or empty text; null and undefined are not. Lists of
 * numbers may be typed arrays.
 */
export type Init<T> = T extends Uint8Array
  ? Uint8Array | Uint8ClampedArray
  : T extends readonly (infer E)[]
    ? [E] extends [number | boolean]
      ? ArrayLike<E>
      : readonly Init<E>[]
    : T extends object
      ? { readonly [K in keyof T]?: Init<T[K]> | null | undefined }
      : T;
