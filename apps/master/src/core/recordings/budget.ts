import { ServiceError, type RecordingBudget } from '@ubii/proto';
import type { Limits } from '../limits/index.ts';

/** The budget of a recording, with the defaults of the master for what is 0. [RC-16] @throws ServiceError for impossible numbers */
export function budgetOf(budget: RecordingBudget | undefined, limits: Limits): RecordingBudget {
  const { maxDurationMs = 0, maxBytes = 0, minFreeBytes = 0 } = budget ?? {};
  for (const [name, value] of Object.entries({ maxDurationMs, maxBytes, minFreeBytes })) {
    if (value >= 0 && Number.isFinite(value)) continue;
    throw new ServiceError(
      'invalid_argument',
      `The budget has ${name} ${value}, but it is a number from 0 on; 0 means the default of the master.`,
    );
  }
  const { recordingMs, recordingBytes, recordingFreeBytes } = limits;
  return {
    maxDurationMs: Math.min(maxDurationMs || recordingMs, recordingMs),
    maxBytes: Math.min(maxBytes || recordingBytes, recordingBytes),
    minFreeBytes: minFreeBytes || recordingFreeBytes,
  };
}
