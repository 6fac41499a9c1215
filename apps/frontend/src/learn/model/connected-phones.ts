import { ClientState, type Client } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';
import type { PhoneFact } from './facts.ts';

/** The clients that are connected and have the smart device: phones, and frames of this page alike. */
export function connectedPhones(clients: readonly Client[]): PhoneFact[] {
  return clients
    .filter(({ state }) => state === ClientState.ACTIVE)
    .filter(({ devices }) => devices.some(({ name }) => name === SMART_DEVICE))
    .map(({ id, name }) => ({ id, name }));
}
