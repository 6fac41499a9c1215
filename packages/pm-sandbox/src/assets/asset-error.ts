/** `missing`: there is no such set. `damaged`: it is not what its manifest says. `unreachable`: it could not be read. */
export type AssetErrorCode = 'missing' | 'damaged' | 'unreachable';

/** Why an asset set cannot be used, in one or two sentences for people. */
export class AssetError extends Error {
  readonly code: AssetErrorCode;

  constructor(code: AssetErrorCode, message: string) {
    super(message);
    this.name = 'AssetError';
    this.code = code;
  }
}

/** A set that is not there, with the way to it. */
export function missingSet(name: string): AssetError {
  return new AssetError(
    'missing',
    `The master has no asset set ${name}. Put its files into the folder models/${name} of the data directory of the master, then start the session again.`,
  );
}
