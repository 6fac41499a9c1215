import type { LimitInfo } from './limit.ts';
import { MESSAGE_LIMITS } from './messages.ts';
import { REQUEST_BODY_LIMITS } from './request-bodies.ts';
import { TEXT_LIMITS } from './texts.ts';
import { TOPIC_LIMITS } from './topics.ts';
import { CLIENT_LIMITS } from './clients.ts';
import { CONNECTION_LIMITS } from './connections.ts';
import { ACCESS_LIMITS } from './access.ts';
import { SUBSCRIPTION_LIMITS } from './subscriptions.ts';
import { DELIVERY_LIMITS } from './delivery.ts';
import { RECORDING_LIMITS } from './recordings.ts';
import { SESSION_LIMITS } from './sessions.ts';
import { STUDY_LIMITS } from './studies.ts';

/**
 * All limits of the master. A request beyond a limit fails with `resource_exhausted` and the name of the
 * limit. The master counts these errors, and shows them in its metrics, status and problems. Units are
 * part of the names.
 */
export const LIMITS = {
  ...MESSAGE_LIMITS,
  ...REQUEST_BODY_LIMITS,
  ...TEXT_LIMITS,
  ...TOPIC_LIMITS,
  ...CLIENT_LIMITS,
  ...CONNECTION_LIMITS,
  ...ACCESS_LIMITS,
  ...SUBSCRIPTION_LIMITS,
  ...DELIVERY_LIMITS,
  ...SESSION_LIMITS,
  ...RECORDING_LIMITS,
  ...STUDY_LIMITS,
} as const satisfies Record<string, LimitInfo>;

/** Name of a limit, as in errors, metrics and problems. */
export type LimitName = keyof typeof LIMITS;

/** The values of all limits of one master. */
export type Limits = { readonly [L in LimitName]: number };

/** The default values. */
export const DEFAULT_LIMITS = Object.fromEntries(
  Object.entries(LIMITS).map(([name, { value }]) => [name, value]),
) as Limits;
