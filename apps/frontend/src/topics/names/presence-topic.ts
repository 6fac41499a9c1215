import { componentTopic } from '@ubii/proto';

/** Where an editor says what it has open. [EX-49] */
export const PRESENCE_GLOB = presenceTopic('*');

/** @param clientId `*` for all clients */
export function presenceTopic(clientId: string): string {
  return componentTopic(clientId, 'graph_editor', 'presence');
}

/** The client whose editor says something on a topic; undefined for another topic. */
export function clientOfPresence(topic: string): string | undefined {
  const clientId = topic.split('/')[1];
  return clientId !== undefined && topic === presenceTopic(clientId) ? clientId : undefined;
}

export const isPresenceTopic = (topic: string): boolean => clientOfPresence(topic) !== undefined;
