import { exampleTopic, POINTER_COMPONENT } from '../../devices/pointer-topic.ts';
import { topicsThatEnd } from '../model/checks.ts';
import type { LessonFacts, TopicFact } from '../model/facts.ts';

export const TOUCH_POSITION = '/web-interface-smart-device/touch_position';

/** Pointer topic of this client's browser. */
export const pointerTopic = (clientId: string): string => exampleTopic(clientId, POINTER_COMPONENT);

/** Topic that sessions of lessons write to: one per client, so that users do not interfere. */
export const lessonTopic = (clientId: string, name: string): string =>
  `/learn/${clientId.slice(0, 8)}/${name}`;

/** Name of a lesson's session, one per client. */
export const lessonSession = (clientId: string, name: string): string =>
  `lesson-${name}-${clientId.slice(0, 4)}`;

export const touchOf = (facts: LessonFacts): TopicFact | undefined =>
  topicsThatEnd(facts, TOUCH_POSITION)[0];

export const pointerOf = ({ ownId, topics }: LessonFacts): TopicFact | undefined =>
  topics.get(pointerTopic(ownId));

/** Returns a function for a topic of the lesson. */
export const outputOf =
  (name: string) =>
  ({ ownId, topics }: LessonFacts): TopicFact | undefined =>
    topics.get(lessonTopic(ownId, name));
