export { default as PartyPhone } from './PartyPhone.vue';
export type { PhoneFacts, PhoneLink } from './phone-link.ts';
