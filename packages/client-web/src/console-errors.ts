import type { ErrorHandler, ErrorSource } from './core/ports/error-handler.ts';

/** Errors that are remembered as written. Further ones are not written: a callback may fail for every record. */
const MAX_ERRORS = 100;

const PLACES: Record<ErrorSource, string> = {
  listener: 'a callback',
  'identity-storage': 'the identity storage',
};

/** Writes errors of the program's own code to the console, equal ones once. */
export function createConsoleErrors(): ErrorHandler {
  const written = new Set<string>();
  return (error, source) => {
    const text = error instanceof Error ? `${error.name}: ${error.message}` : typeof error;
    const key = `${source} ${text}`;
    if (written.has(key) || written.size >= MAX_ERRORS) return;
    written.add(key);
    console.error(`Ubi-Interact client: error in ${PLACES[source]} of this program:`, error);
  };
}
