import { ServiceError } from '@ubii/proto';
import { shallowRef } from 'vue';
import type { OwnTrouble } from '../page/own-trouble.ts';

/** Reason why this page could not register its device; shown by the shell. */
export const deviceRefusal = shallowRef<OwnTrouble>();

/** @param error reason of the failed registration */
export function refusalOf(device: string, error: unknown): OwnTrouble | undefined {
  // Other errors end the client, which the shell shows by itself.
  if (!(error instanceof ServiceError)) return undefined;
  return {
    key: `device_refused ${device}`,
    code: 'device_refused',
    text: `This device was refused, so nothing is sent: ${error.message}`,
    remedy:
      error.code === 'permission_denied'
        ? 'Ask the host for a code that lets this device send.'
        : 'Reload the page to try again.',
    sessionId: '',
  };
}
