/**
 * Source of an error in the program's own code: `listener`: a callback, such as that of `onRecord`; `identity-storage`:
 * the storage of the identity.
 */
export type ErrorSource = 'listener' | 'identity-storage';

/** Takes an error of the program's own code. */
export type ErrorHandler = (error: unknown, source: ErrorSource) => void;
