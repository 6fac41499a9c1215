import { ServiceError, type ServiceErrorCode } from '@ubii/proto';

/** An error on its way: copying one between threads would lose its class and its members. */
export interface PackedError {
  readonly name: string;
  readonly message: string;
  /** Of a `ServiceError`. */
  readonly code?: ServiceErrorCode;
  readonly details?: Readonly<Record<string, unknown>>;
  /** What caused it, as text for a log. */
  readonly cause?: string;
}

export function packError(thrown: unknown): PackedError {
  if (!(thrown instanceof Error)) return { name: 'Error', message: String(thrown) };
  const { name, message, cause } = thrown;
  const packed = { name, message, ...(cause !== undefined && { cause: String(cause) }) };
  if (!(thrown instanceof ServiceError)) return packed;
  return { ...packed, code: thrown.code, details: thrown.details };
}

export function unpackError({ name, message, code, details = {}, cause }: PackedError): Error {
  if (code !== undefined) return new ServiceError(code, message, { details, cause });
  const error = new Error(message, cause === undefined ? undefined : { cause });
  error.name = name;
  return error;
}
