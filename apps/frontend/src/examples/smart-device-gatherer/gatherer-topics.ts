import { componentTopic } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';

/** What the page hears of every phone, each with the client's id in the topic. */
export const TOUCHES_GLOB = '/*/touch_events';
export const MOTION_GLOB = componentTopic('*', SMART_DEVICE, 'linear_acceleration');
export const NEAR_GLOB = componentTopic('*', SMART_DEVICE, 'is_near');

/** How near is near, in parts of the pad: an input of the session, the same for everybody. */
export const DISTANCE_TOPIC = '/examples/touch-proximity/distance';
/** What the module takes while nobody has said. */
export const DEFAULT_DISTANCE = 0.1;
/** Who were near stay near so much farther, as the module has it. */
export const HYSTERESIS = 0.02;

/** The name of the one session. */
export const PROXIMITY_SESSION = 'touch-proximity';

/** Where a phone is told whether somebody is near. */
export function nearTopic(clientId: string): string {
  return componentTopic(clientId, SMART_DEVICE, 'is_near');
}

/** The client a topic of a phone belongs to. */
export function clientOfTopic(topic: string): string {
  return topic.split('/')[1] ?? '';
}
