import type { ErrorHandler, ErrorSource } from '../ports/error-handler.ts';

/** Reports what the promise of an async callback rejects with; `result` may be anything else, too. */
export function reportRejection(result: unknown, source: ErrorSource, onError: ErrorHandler): void {
  if (result instanceof Promise) result.catch((error: unknown) => onError(error, source));
}

/** Calls `onError`; what goes wrong in it goes to `fallback`. */
export function withFallback(onError: ErrorHandler, fallback: ErrorHandler): ErrorHandler {
  return (error, source) => {
    try {
      reportRejection(onError(error, source), 'listener', fallback);
    } catch (fault) {
      fallback(fault, 'listener');
    }
  };
}
