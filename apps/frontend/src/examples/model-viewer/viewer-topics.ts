import { componentTopic } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';

/** Device of a browser that rotates the model with mouse, fingers or keys. */
export const VIEWER_DEVICE = 'web-example-model-viewer';
/** The component has the same name as on a phone. */
export const TURN_COMPONENT = 'orientation_quaternion';

/** Returns the topic of the smoothed orientation of a client. */
export function smoothedTopic(clientId: string): string {
  return `/examples/model-viewer/${clientId}/${TURN_COMPONENT}`;
}

/** Returns the topic of a client's orientation. */
export function turnTopic(clientId: string, isPhone: boolean): string {
  return componentTopic(clientId, isPhone ? SMART_DEVICE : VIEWER_DEVICE, TURN_COMPONENT);
}

/** The orientations of all phones. */
export const PHONE_TURNS_GLOB = turnTopic('*', true);

/** Returns the client of a topic of a device. */
export function clientOfTopic(topic: string): string {
  return topic.split('/')[1] ?? '';
}
