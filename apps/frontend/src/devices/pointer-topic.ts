import { componentTopic } from '@ubii/proto';

/** Device and component names that existing Ubi-Interact applications use. */
export const POINTER_DEVICE = 'web-example-mouse-pointer';
export const POINTER_COMPONENT = 'mouse_client_position';
/** Component with the mirrored pointer from the session. */
export const MIRRORED_COMPONENT = 'mouse_server_position';
/** Components with the axes that the session mirrors. */
export const MIRROR_X_COMPONENT = 'mirror_mouse_x';
export const MIRROR_Y_COMPONENT = 'mirror_mouse_y';

/** Matches the pointer topics of all clients. */
export const POINTER_GLOB = componentTopic('*', POINTER_DEVICE, POINTER_COMPONENT);

/** Returns a topic of the example in the namespace of a client. */
export function exampleTopic(clientId: string, component: string): string {
  return componentTopic(clientId, POINTER_DEVICE, component);
}

/** Returns the client of a pointer topic; `undefined` for another topic. */
export function clientOfPointerTopic(topic: string): string | undefined {
  const clientId = topic.split('/')[1];
  return clientId !== undefined && topic === exampleTopic(clientId, POINTER_COMPONENT)
    ? clientId
    : undefined;
}
