import { ClientState, type Client } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';
import type { PhoneFact } from './facts.ts';

/** Returns the connected clients with a smart device: phones, and frames of this page. */
export function connectedPhones(clients: readonly Client[]): PhoneFact[] {
  return clients
    .filter(({ state }) => state === ClientState.ACTIVE)
    .filter(({ devices }) => devices.some(({ name }) => name === SMART_DEVICE))
    .map(({ id, name }) => ({ id, name }));
}
