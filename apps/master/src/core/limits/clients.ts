import { KIB, MIB, limit } from './limit.ts';

/** Limits of clients and devices. */
export const CLIENT_LIMITS = {
  clients: limit(
    10_000,
    'clients',
    'storage',
    'Registered clients. Ten times the largest expected number; a client takes a few KiB.',
  ),
  devices: limit(
    20_000,
    'devices',
    'storage',
    'Devices of all clients. Two for each client at the limit of clients.',
  ),
  devicesPerClient: limit(
    1_024,
    'devices',
    'storage',
    'Devices of one client. A phone has one or two, a motion-capture system a few dozen.',
  ),
  devicesPerPlayer: limit(
    16,
    'devices',
    'storage',
    'The same limit for a player. A phone has one or two devices.',
  ),
  componentsPerDevice: limit(
    1_024,
    'components',
    'storage',
    'Components of one device. A full body with fingers has some 100 joints.',
  ),
  registrationBytesPerClient: limit(
    4 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of the registration of one client, with its modules and devices.',
  ),
  registrationBytesPerPlayer: limit(
    256 * KIB,
    'bytes',
    'storage',
    'The same limit for a player or viewer. A phone with ten components registers some 3 KiB.',
  ),
  registrationBytes: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of the registrations of all clients.',
  ),
  announcementBytes: limit(
    8 * KIB,
    'bytes',
    'rates',
    'Size up to which the whole registration is announced when a client changes. For larger registrations, only name, state and revision are announced. A phone with 20 components registers some 6 KiB.',
  ),
  clientNewsBytesPerSecond: limit(
    8 * KIB,
    'bytes/s',
    'rates',
    'Average rate of announcements about one client to each subscriber, with bursts of 4 times as much. Further announcements are delayed, and only the last state is sent.',
  ),
  unavailableRetentionMs: limit(
    20 * 60_000,
    'ms',
    'time',
    'Time until an unavailable client is removed. A phone that sleeps during a break resumes as the same client.',
  ),
} as const;
