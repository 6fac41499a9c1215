import { componentTopic } from '@ubii/proto';

/** Device and component names that other apps of the field rely on. */
export const POINTER_DEVICE = 'web-example-mouse-pointer';
export const POINTER_COMPONENT = 'mouse_client_position';
/** Where the pointer comes back from the session. */
export const MIRRORED_COMPONENT = 'mouse_server_position';
/** Two switches: in which axis the session mirrors. */
export const MIRROR_X_COMPONENT = 'mirror_mouse_x';
export const MIRROR_Y_COMPONENT = 'mirror_mouse_y';

/** Selects the pointer topics of all clients. */
export const POINTER_GLOB = componentTopic('*', POINTER_DEVICE, POINTER_COMPONENT);

/** A topic of the example in the name space of a client: people do not meet each other's. */
export function exampleTopic(clientId: string, component: string): string {
  return componentTopic(clientId, POINTER_DEVICE, component);
}

/** The client a pointer topic belongs to, `undefined` for another topic. */
export function clientOfPointerTopic(topic: string): string | undefined {
  const clientId = topic.split('/')[1];
  return clientId !== undefined && topic === exampleTopic(clientId, POINTER_COMPONENT)
    ? clientId
    : undefined;
}
