import type { ComponentInit } from '@ubii/client-web';
import { componentTopic } from '@ubii/proto';
import { exampleTopic, POINTER_COMPONENT } from '../../../devices/pointer-topic.ts';
import type { InputName } from './input-names.ts';

/** The device that publishes clicks and keys of a page. */
export const PAGE_DEVICE = 'web-page';

export const PAGE_COMPONENTS = [
  {
    name: 'is_pressed',
    format: 'bool',
    tags: ['pointer', 'button'],
    description: 'True while the pointer is pressed on this page.',
  },
  {
    name: 'escape',
    format: 'bool',
    tags: ['button', 'keyboard'],
    description: 'True while the Escape key is held.',
  },
  {
    name: 'button',
    format: 'keyEvent',
    tags: ['button', 'keyboard'],
    description: 'Keys, pressed and released, while no text is being typed.',
  },
] as const satisfies readonly ComponentInit[];

const COMPONENT_OF = { pressed: 'is_pressed', escape: 'escape', key: 'button' } as const;

/** Returns the topic of an input from the page of a client. */
export function inputTopic(clientId: string, input: InputName): string {
  return input === 'pointer'
    ? exampleTopic(clientId, POINTER_COMPONENT)
    : componentTopic(clientId, PAGE_DEVICE, COMPONENT_OF[input]);
}
