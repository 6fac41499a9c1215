import { DATA_FORMATS, matchesProfile } from '@ubii/proto';
import type { Component, DataFormat } from '@ubii/proto';

/** Describes components by what they have in common. A component matches when every member given matches. */
export interface ComponentProfile {
  readonly id?: string;
  readonly name?: string;
  /** Data format of its records, or the message format as it was registered. */
  readonly format?: DataFormat | (string & {});
  readonly deviceId?: string;
  /** Required tags: all of these. */
  readonly tags?: readonly string[];
}

/** The message format a component of this data format is registered with. */
export function messageFormatOf(format: string): string {
  return isDataFormat(format) ? DATA_FORMATS[format].messageType : format;
}

/** The profile as the master takes it. [CL-20] */
export function profileToMessage(profile: ComponentProfile): Partial<Component> {
  return {
    ...(profile.id ? { id: profile.id } : {}),
    ...(profile.name ? { name: profile.name } : {}),
    ...(profile.format ? { messageFormat: messageFormatOf(profile.format) } : {}),
    ...(profile.deviceId ? { deviceId: profile.deviceId } : {}),
    ...(profile.tags?.length ? { tags: [...profile.tags] } : {}),
  };
}

/** Whether the master would select the component by this profile. [CL-20] */
export function selectsComponent(profile: ComponentProfile, component: Component): boolean {
  return matchesProfile(component, profileToMessage(profile));
}

function isDataFormat(format: string): format is DataFormat {
  return Object.hasOwn(DATA_FORMATS, format);
}
