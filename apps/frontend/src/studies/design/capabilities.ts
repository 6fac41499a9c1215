import type { Client, StudyDevice } from '@ubii/proto';

/** What identifies a required device. */
export type Capability = 'tag' | 'dataFormat' | 'topicPattern';

export const CAPABILITIES: readonly { readonly value: Capability; readonly text: string }[] = [
  { value: 'tag', text: 'Tag' },
  { value: 'dataFormat', text: 'Data format' },
  { value: 'topicPattern', text: 'Topic pattern' },
];

/** The member of a device that is set; a tag when none is. */
export function capabilityOf({ dataFormat, topicPattern }: StudyDevice): Capability {
  if (dataFormat !== '') return 'dataFormat';
  return topicPattern !== '' ? 'topicPattern' : 'tag';
}

/** A device that is identified by this only. */
export const identifiedBy = (
  device: StudyDevice,
  capability: Capability,
  value: string,
): StudyDevice => ({ ...device, tag: '', dataFormat: '', topicPattern: '', [capability]: value });

/** Tags of all devices and components, sorted. */
export function tagsOf(clients: readonly Pick<Client, 'devices'>[]): readonly string[] {
  const devices = clients.flatMap((client) => client.devices);
  const parts = [...devices, ...devices.flatMap(({ components }) => components)];
  return [...new Set(parts.flatMap(({ tags }) => tags))].sort((a, b) => a.localeCompare(b, 'en'));
}

/** Options for what the master has now, with the value that is set even when nothing has it now. */
export const optionsFor = (known: readonly string[], value: string) =>
  [...new Set([...(value === '' ? [] : [value]), ...known])].map((one) => ({
    value: one,
    text: known.includes(one) ? one : `${one} (none now)`,
  }));
