import { componentTopic } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';

/** The topics of all phones that the page subscribes to. Each topic has the id of the client. */
export const TOUCHES_GLOB = '/*/touch_events';
export const MOTION_GLOB = componentTopic('*', SMART_DEVICE, 'linear_acceleration');
export const NEAR_GLOB = componentTopic('*', SMART_DEVICE, 'is_near');

/** Distance of near touches, as a fraction of the pad: an input of the session, shared by all clients. */
export const DISTANCE_TOPIC = '/examples/touch-proximity/distance';
/** The module's default distance. */
export const DEFAULT_DISTANCE = 0.1;
/** Additional distance at which near touches stay near: the default of the module. */
export const HYSTERESIS = 0.02;

/** Name of the shared session. */
export const PROXIMITY_SESSION = 'Touch proximity';

/** Returns the topic that tells a phone whether another touch is near. */
export function nearTopic(clientId: string): string {
  return componentTopic(clientId, SMART_DEVICE, 'is_near');
}

/** Returns the client of a phone's topic. */
export function clientOfTopic(topic: string): string {
  return topic.split('/')[1] ?? '';
}
