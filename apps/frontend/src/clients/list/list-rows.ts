import type { Component, Device } from '@ubii/proto';
import type { ClientView } from '../model/client-view.ts';

interface Place {
  /** Unique in the list, and stable while the element exists. */
  readonly key: string;
  readonly level: 1 | 2 | 3;
  /** Position among its siblings, from 1. */
  readonly position: number;
  readonly setSize: number;
  /** `undefined` for rows without children. */
  readonly isExpanded: boolean | undefined;
  readonly view: ClientView;
}

/** Row of the list: a client, one of its devices, or a component of a device. */
export type ListRow =
  | (Place & { readonly kind: 'client' })
  | (Place & { readonly kind: 'device'; readonly device: Device })
  | (Place & {
      readonly kind: 'component';
      readonly device: Device;
      readonly component: Component;
    });

/** Returns the rows of clients in this order, with the children of expanded rows. */
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

/** Key in `expanded` of a row whose expansion differs from the default. */
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
