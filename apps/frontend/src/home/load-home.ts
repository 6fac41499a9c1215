/** Windows in which Home is that of a phone. */
export const PHONE = '(max-width: 759px)';

export const loadBack = () => import('./back/BackHome.vue');
export const loadPhone = () => import('./phone/PhoneHome.vue');
