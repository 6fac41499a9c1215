export { default as PartyPhone } from './PartyPhone.vue';
export type { PhoneFacts, PhoneLink } from '../net/phone/phone-link.ts';
