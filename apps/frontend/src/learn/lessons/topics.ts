import { exampleTopic, POINTER_COMPONENT } from '../../devices/pointer-topic.ts';
import { topicsThatEnd } from '../model/checks.ts';
import type { LessonFacts, TopicFact } from '../model/facts.ts';

export const TOUCH_POSITION = '/web-interface-smart-device/touch_position';

/** The pointer of the browser of this client. */
export const pointerTopic = (clientId: string): string => exampleTopic(clientId, POINTER_COMPONENT);

/** A topic that the sessions of lessons write to: each client has its own, so that lessons do not meet. */
export const lessonTopic = (clientId: string, name: string): string =>
  `/learn/${clientId.slice(0, 8)}/${name}`;

/** The name of a lesson's session, one for each client. */
export const lessonSession = (clientId: string, name: string): string =>
  `lesson-${name}-${clientId.slice(0, 4)}`;

export const touchOf = (facts: LessonFacts): TopicFact | undefined =>
  topicsThatEnd(facts, TOUCH_POSITION)[0];

export const pointerOf = ({ ownId, topics }: LessonFacts): TopicFact | undefined =>
  topics.get(pointerTopic(ownId));

/** Selects a topic of the lesson. */
export const outputOf =
  (name: string) =>
  ({ ownId, topics }: LessonFacts): TopicFact | undefined =>
    topics.get(lessonTopic(ownId, name));
