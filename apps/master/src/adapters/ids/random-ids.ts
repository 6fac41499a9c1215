import { randomUUID } from 'node:crypto';

import type { IdSource } from '../../core/ports/index.ts';

/** Ids from the system's cryptographic random numbers. */
export const randomIds: IdSource = { uuid: () => randomUUID() };
