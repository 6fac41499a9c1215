export { default as PartyScreen } from './PartyScreen.vue';
export type { Invitation, ScreenLink } from './screen-link.ts';
