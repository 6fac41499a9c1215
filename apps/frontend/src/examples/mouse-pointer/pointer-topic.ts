import { componentTopic } from '@ubii/proto';

/** Device and component names that other apps of the field rely on. */
export const POINTER_DEVICE = 'web-example-mouse-pointer';
export const POINTER_COMPONENT = 'mouse_client_position';

/** Selects the pointer topics of all clients. */
export const POINTER_GLOB = componentTopic('*', POINTER_DEVICE, POINTER_COMPONENT);

/** The client a pointer topic belongs to, `undefined` for another topic. */
export function clientOfPointerTopic(topic: string): string | undefined {
  const clientId = topic.split('/')[1];
  return clientId !== undefined &&
    topic === componentTopic(clientId, POINTER_DEVICE, POINTER_COMPONENT)
    ? clientId
    : undefined;
}
