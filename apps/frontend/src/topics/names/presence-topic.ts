import { componentTopic } from '@ubii/proto';

/** Topics on which editors publish the session that they have open. [EX-49] */
export const PRESENCE_GLOB = presenceTopic('*');

/** @param clientId `*` for all clients */
export function presenceTopic(clientId: string): string {
  return componentTopic(clientId, 'graph_editor', 'presence');
}

/** Returns the client whose editor publishes on a topic; undefined for other topics. */
export function clientOfPresence(topic: string): string | undefined {
  const clientId = topic.split('/')[1];
  return clientId !== undefined && topic === presenceTopic(clientId) ? clientId : undefined;
}

export const isPresenceTopic = (topic: string): boolean => clientOfPresence(topic) !== undefined;
