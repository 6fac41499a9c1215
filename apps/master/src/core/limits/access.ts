import { limit } from './limit.ts';

/** Limits of invitations, join codes and the audit log. */
export const ACCESS_LIMITS = {
  grants: limit(
    256,
    'grants',
    'storage',
    'Invitations. Enough for one for each group of an event and one for each start of the master.',
  ),
  wrongCodesPerAddress: limit(
    10,
    'codes/s',
    'rates',
    'Wrong join codes from one address. Callers that share their address with an attacker can still join after a few attempts. At this rate, one address guesses a code that is valid for 12 hours with a probability of 4 in 10 million.',
  ),
  wrongCodesPerNetwork: limit(
    20,
    'codes/s',
    'rates',
    'The same limit for one IPv6 /64 network. One address uses at most half of it.',
  ),
  wrongCodes: limit(
    200,
    'codes/s',
    'rates',
    'The same limit for all addresses. A code is valid for at most 12 hours, which allows 9 million attempts for 10^12 possible codes.',
  ),
  auditEntries: limit(
    10_000,
    'entries',
    'storage',
    'Entries of the audit log that clients can read. An entry takes some 300 bytes, at most 2 KiB; the file has at most twice as many entries.',
  ),
  auditEntriesPerSecond: limit(
    2,
    'entries/s',
    'rates',
    'Average rate of audit entries of one caller, with bursts of one minute of this rate. Further entries are only counted, and the next entry contains their number.',
  ),
} as const;
