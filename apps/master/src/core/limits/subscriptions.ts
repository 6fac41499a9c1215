import { limit } from './limit.ts';

/** Limits of subscriptions. */
export const SUBSCRIPTION_LIMITS = {
  subscriptions: limit(
    1_048_576,
    'subscriptions',
    'subscriptions',
    'Subscriptions by topic of all clients. Enough for 100 clients with 10 000 each; a subscription takes some 100 bytes.',
  ),
  subscriptionsPerClient: limit(
    32_768,
    'subscriptions',
    'subscriptions',
    'Subscriptions by topic of one client. Three times the 10 000 topics of a large program.',
  ),
  patternsPerClient: limit(
    1_024,
    'expressions',
    'subscriptions',
    'Regular expressions of one client. Each new topic is matched against all of them.',
  ),
  patternsPerParticipant: limit(
    256,
    'expressions',
    'subscriptions',
    'The same limit for a participant with an invitation. A usual program has a few.',
  ),
  patternsPerPlayer: limit(
    32,
    'expressions',
    'subscriptions',
    'The same limit for a player or viewer. Thirty phones with one invitation fit into the share of the invitation.',
  ),
  patterns: limit(
    4_096,
    'expressions',
    'subscriptions',
    'Different regular expressions of all clients. Limits the matching cost of a new topic.',
  ),
  patternMatchMs: limit(
    500,
    'ms',
    'subscriptions',
    'Time to match the regular expressions of one client without a pause. A usual pattern takes 0.001 ms per topic, a pattern that is slow on purpose up to 30 ms.',
  ),
  patternMatchMsPerSecond: limit(
    50,
    'ms/s',
    'subscriptions',
    'The average of the same time per second: 5 % of the event loop.',
  ),
  profilesPerClient: limit(
    256,
    'profiles',
    'subscriptions',
    'Component profiles of one client. Each registered component is matched against all of them.',
  ),
  profilesPerPlayer: limit(
    16,
    'profiles',
    'subscriptions',
    'The same limit for a player or viewer. Thirty phones with one invitation fit into the share of the invitation.',
  ),
  profiles: limit(
    2_048,
    'profiles',
    'subscriptions',
    'Different component profiles of all clients.',
  ),
} as const;
