"""Contacts, impacts and resets, against closed forms and an oracle of contact modes."""
