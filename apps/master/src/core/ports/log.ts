/** Fields of a log line besides its message: plain values, written unchanged. */
export type LogFields = Readonly<Record<string, string | number | boolean | undefined>>;

/** Structured log. Nothing is logged per record. */
export interface Log {
  /** An unexpected error that an operator has to check. */
  error(message: string, fields?: LogFields): void;
  /** Something was refused or fails; the master continues. */
  warn(message: string, fields?: LogFields): void;
  /** Something a person running the master wants to know. */
  info(message: string, fields?: LogFields): void;
  /** Something that helps to find a fault. */
  debug(message: string, fields?: LogFields): void;
  /** A log that adds `fields` to each of its lines. */
  child(fields: LogFields): Log;
}
