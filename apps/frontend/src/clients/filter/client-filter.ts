import { ClientState } from '@ubii/proto';
import { findClientColumn, type ClientColumnKey } from '../model/client-columns.ts';
import type { ClientKind, ClientView } from '../model/client-view.ts';

/** Filter, order and view of the clients, as stored in the URL. */
export interface ClientWishes {
  readonly text: string;
  readonly state: 'here' | 'silent' | 'lost' | undefined;
  readonly kind: ClientKind | undefined;
  /** Name of the master. */
  readonly master: string | undefined;
  readonly isBroken: boolean;
  readonly sort: ClientColumnKey;
  readonly isDescending: boolean;
  /** `load`: clients ranked by the load they cause. */
  readonly view: 'all' | 'load';
}

export const NO_WISHES: ClientWishes = {
  text: '',
  state: undefined,
  kind: undefined,
  master: undefined,
  isBroken: false,
  sort: 'name',
  isDescending: false,
  view: 'all',
};

const STATES = {
  here: ClientState.ACTIVE,
  silent: ClientState.INACTIVE,
  lost: ClientState.UNAVAILABLE,
};
const KINDS: readonly string[] = ['phone', 'browser', 'node', 'program'] satisfies ClientKind[];

type Query = Readonly<Record<string, unknown>>;

const first = (value: unknown): string => {
  const text: unknown = Array.isArray(value) ? value[0] : value;
  return typeof text === 'string' ? text : '';
};

/** Parses the query of the URL; ignores invalid values. */
export function readWishes(query: Query): ClientWishes {
  const state = first(query['state']);
  const kind = first(query['kind']);
  const column = findClientColumn(first(query['sort'])) ?? findClientColumn(NO_WISHES.sort)!;
  const order = first(query['order']);
  return {
    text: first(query['q']),
    state: Object.hasOwn(STATES, state) ? (state as keyof typeof STATES) : undefined,
    kind: KINDS.includes(kind) ? (kind as ClientKind) : undefined,
    master: first(query['master']) || undefined,
    isBroken: first(query['broken']) === '1',
    sort: column.key,
    isDescending: order === '' ? column.first === 'descending' : order === 'down',
    view: first(query['view']) === 'load' ? 'load' : 'all',
  };
}

/** Query of the URL for these options, without defaults, to keep URLs short. */
export function writeWishes(wishes: ClientWishes): Record<string, string> {
  const column = findClientColumn(wishes.sort)!;
  const query: Record<string, string> = {};
  if (wishes.text !== '') query['q'] = wishes.text;
  if (wishes.state) query['state'] = wishes.state;
  if (wishes.kind) query['kind'] = wishes.kind;
  if (wishes.master) query['master'] = wishes.master;
  if (wishes.isBroken) query['broken'] = '1';
  if (wishes.sort !== NO_WISHES.sort) query['sort'] = wishes.sort;
  if (wishes.isDescending !== (column.first === 'descending')) {
    query['order'] = wishes.isDescending ? 'down' : 'up';
  }
  if (wishes.view !== NO_WISHES.view) query['view'] = wishes.view;
  return query;
}

/** True when some clients may be hidden. */
export const isFiltering = ({ text, state, kind, master, isBroken }: ClientWishes): boolean =>
  text.trim() !== '' || [state, kind, master].some((one) => one !== undefined) || isBroken;

/** Filters clients. Every word of the search must occur in the texts of a client. */
export function filterClients(
  views: readonly ClientView[],
  { text, state, kind, master, isBroken }: ClientWishes,
): ClientView[] {
  const wordsOfText = text.toLocaleLowerCase().split(/\s+/).filter(Boolean);
  return views.filter(
    (view) =>
      (state === undefined || view.client.state === STATES[state]) &&
      (kind === undefined || view.kinds.has(kind)) &&
      (master === undefined || view.master === master) &&
      (!isBroken || view.isBroken) &&
      (wordsOfText.length === 0 || hasWords(view, wordsOfText)),
  );
}

function hasWords(
  { client, agent, master, activity }: ClientView,
  wanted: readonly string[],
): boolean {
  const said = [
    client.name,
    client.id,
    client.description,
    agent,
    master,
    activity?.library ?? '',
    ...client.tags,
    ...client.processingModules.map(({ name }) => name),
    ...client.devices.flatMap(({ name, components }) => [
      name,
      ...components.flatMap((component) => [component.name, component.topic]),
    ]),
  ];
  const text = said.join('\n').toLocaleLowerCase();
  return wanted.every((word) => text.includes(word));
}

/** Sorts clients; unknown values last, equal ones in the order of names. */
export function sortClients(
  views: readonly ClientView[],
  { sort, isDescending }: Pick<ClientWishes, 'sort' | 'isDescending'>,
): ClientView[] {
  const column = findClientColumn(sort)!;
  const sign = isDescending ? -1 : 1;
  return views
    .map((view) => ({ view, value: column.valueOf(view) }))
    .sort((a, b) => {
      if (a.value === undefined || b.value === undefined) {
        return (
          Number(a.value === undefined) - Number(b.value === undefined) || byName(a.view, b.view)
        );
      }
      return sign * compare(a.value, b.value) || byName(a.view, b.view);
    })
    .map(({ view }) => view);
}

function compare(a: number | string, b: number | string): number {
  if (typeof a === 'string' && typeof b === 'string') return a.localeCompare(b);
  return Number(a) - Number(b);
}

const byName = (a: ClientView, b: ClientView): number =>
  a.label.localeCompare(b.label) || a.client.id.localeCompare(b.client.id);
