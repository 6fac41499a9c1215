import { ACCESS_SERVICES } from './access.ts';
import { ASSET_SET_SERVICES } from './asset-sets.ts';
import { BRIDGE_SERVICES } from './bridges.ts';
import { CLIENT_CONTROL_SERVICES } from './client-control.ts';
import { CLIENT_SERVICES } from './clients.ts';
import type { Service } from './define-service.ts';
import { DEVICE_SERVICES } from './devices.ts';
import { listingServices } from './listings.ts';
import { MODULE_SERVICES } from './modules.ts';
import { MONITORING_SERVICES } from './monitoring.ts';
import { PERSONAL_DATA_SERVICES } from './personal-data.ts';
import { RECORDING_SERVICES } from './recordings.ts';
import { REPLAY_SERVICES } from './replays.ts';
import { SERVER_SERVICES } from './server.ts';
import { STORED_SESSION_SERVICES } from './session-database.ts';
import { SESSION_SERVICES } from './sessions.ts';
import { STUDY_SERVICES } from './studies.ts';
import { TOPIC_SERVICES } from './topics.ts';

/** Every service this master answers. The others of the protocol are `unimplemented`. */
export const ALL_SERVICES: readonly Service[] = [
  ...SERVER_SERVICES,
  ...listingServices(() => ALL_SERVICES),
  ...TOPIC_SERVICES,
  ...CLIENT_SERVICES,
  ...CLIENT_CONTROL_SERVICES,
  ...DEVICE_SERVICES,
  ...SESSION_SERVICES,
  ...STORED_SESSION_SERVICES,
  ...MODULE_SERVICES,
  ...ACCESS_SERVICES,
  ...MONITORING_SERVICES,
  ...ASSET_SET_SERVICES,
  ...RECORDING_SERVICES,
  ...REPLAY_SERVICES,
  ...PERSONAL_DATA_SERVICES,
  ...STUDY_SERVICES,
  ...BRIDGE_SERVICES,
];

const BY_TOPIC: ReadonlyMap<string, Service> = new Map(
  ALL_SERVICES.map((service) => [service.info.topic, service]),
);

/** The service that answers requests with this topic. */
export function findService(topic: string): Service | undefined {
  return BY_TOPIC.get(topic);
}
