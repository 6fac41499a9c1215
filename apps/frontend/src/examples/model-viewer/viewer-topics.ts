import { componentTopic } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';

/** This browser's stand-in for a phone: turned by mouse, fingers or keys. */
export const VIEWER_DEVICE = 'web-example-model-viewer';
/** The same meaning has the same name as with a phone. */
export const TURN_COMPONENT = 'orientation_quaternion';

/** Where a smoothing session puts the turn of a client. */
export function smoothedTopic(clientId: string): string {
  return `/examples/model-viewer/${clientId}/${TURN_COMPONENT}`;
}

/** The topic a client's turn is on. */
export function turnTopic(clientId: string, isPhone: boolean): string {
  return componentTopic(clientId, isPhone ? SMART_DEVICE : VIEWER_DEVICE, TURN_COMPONENT);
}
