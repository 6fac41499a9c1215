import type { Component, Device } from '@ubii/proto';
import type { ClientView } from '../model/client-view.ts';

interface Place {
  /** Of the whole list, and stays the same while the thing is there. */
  readonly key: string;
  readonly level: 1 | 2 | 3;
  /** From 1, among its siblings. */
  readonly position: number;
  readonly setSize: number;
  /** `undefined` for what has nothing below it. */
  readonly isExpanded: boolean | undefined;
  readonly view: ClientView;
}

/** A row of the list: a client, a device of it, or a component of that. */
export type ListRow =
  | (Place & { readonly kind: 'client' })
  | (Place & { readonly kind: 'device'; readonly device: Device })
  | (Place & {
      readonly kind: 'component';
      readonly device: Device;
      readonly component: Component;
    });

/** The rows of clients in this order, with what is unfolded below them. */
export function listRows(
  views: readonly ClientView[],
  expanded: ReadonlySet<string>,
): readonly ListRow[] {
  return views.flatMap((view, index) => {
    const { devices, id } = view.client;
    const place = { view, level: 1, position: index + 1, setSize: views.length } as const;
    const isExpanded = devices.length === 0 ? undefined : expanded.has(id);
    const row: ListRow = { kind: 'client', key: id, ...place, isExpanded };
    return isExpanded ? [row, ...deviceRows(view, expanded)] : [row];
  });
}

/** Devices are expanded unless the user collapsed them: a user who expands a client wants to see them. */
const closedKey = (key: string): string => `closed ${key}`;

/** What `expanded` holds for a row that is not as it is at first. */
export const foldKey = ({ kind, key }: ListRow): string =>
  kind === 'client' ? key : closedKey(key);

function deviceRows(view: ClientView, expanded: ReadonlySet<string>): ListRow[] {
  const { devices, id } = view.client;
  return devices.flatMap((device, index) => {
    const key = `${id} ${device.id}`;
    const isEmpty = device.components.length === 0;
    const isExpanded = isEmpty ? undefined : !expanded.has(closedKey(key));
    const row: ListRow = {
      kind: 'device',
      key,
      view,
      device,
      level: 2,
      position: index + 1,
      setSize: devices.length,
      isExpanded,
    };
    if (!isExpanded) return [row];
    const below = device.components.map((component, at): ListRow => ({
      kind: 'component',
      key: `${key} ${component.id}`,
      view,
      device,
      component,
      level: 3,
      position: at + 1,
      setSize: device.components.length,
      isExpanded: undefined,
    }));
    return [row, ...below];
  });
}
