/**
 * Where an error of the program's own code comes from: `listener`: a callback, such as that of `onRecord`
 * · `identity-storage`: the storage that keeps the identity.
 */
export type ErrorSource = 'listener' | 'identity-storage';

/** Takes an error of the program's own code. */
export type ErrorHandler = (error: unknown, source: ErrorSource) => void;
