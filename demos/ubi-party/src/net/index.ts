export type * from './messages.ts';
export type * from './room-view.ts';
export * from './topics.ts';
